#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "batten/io/draw/layers.hpp"

namespace batten::drawing {

/// Gives lines without a tone theirs: one name, one tone, in all panels.
class Toning {
public:
    void next_panel() { in_panel_ = 0; }

    Tone line(const LineStyle& style, const std::string& name);

private:
    std::map<std::string, Tone> by_name_;
    std::size_t in_panel_ = 0, named_ = 0;
};

}  // namespace batten::drawing
