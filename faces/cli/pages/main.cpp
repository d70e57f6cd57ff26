#include <exception>
#include <iostream>

#include "batten/io/files.hpp"
#include "pages.hpp"

// Writes the manual page and the completions into a folder.
int main(int argc, char** argv) {
    using namespace batten::cli;
    if (argc != 2) {
        std::cerr << "usage: batten_pages FOLDER\n";
        return 2;
    }
    const std::string folder = argv[1];
    try {
        batten::write_file(folder + "/batten.1", man_page());
        batten::write_file(folder + "/batten.bash", bash_completion());
        batten::write_file(folder + "/_batten", zsh_completion());
        batten::write_file(folder + "/batten.fish", fish_completion());
    } catch (const std::exception& trouble) {
        std::cerr << "batten_pages: " << trouble.what() << '\n';
        return 1;
    }
}
