#pragma once

#include <string>

/// The part of tabulated.hpp that concerns free ends and the rule of three points, as C++.
std::string end_tables();
