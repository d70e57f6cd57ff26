#include <gtest/gtest.h>

#include <cstdlib>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    // The same random cases in every run; RC_PARAMS="seed=..." asks for others.
    setenv("RC_PARAMS", "seed=1997", 0);
    return RUN_ALL_TESTS();
}
