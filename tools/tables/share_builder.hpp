#pragma once

#include <array>
#include <span>
#include <vector>

#include "make/pseudo/tables/tabulated.hpp"

namespace batten::pseudo {

/// turn_parts(), band_cuts() and three_point_shares() of tabulated.hpp.
struct ShareTables {
    std::vector<TurnPart> turns;
    std::array<std::vector<int>, bands> cuts;
    std::vector<Share> shares;
};

/// Above the first kink from the table of J(theta): between two kinks J is convex, so w has one
/// minimum for each band.
ShareTables share_tables(std::span<const double> kinks, std::span<const EndPiece> pieces);

}  // namespace batten::pseudo
