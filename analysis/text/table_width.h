#pragma once

#include <cstddef>

namespace fourpost {

/// Characters of a line that each TextTable has room for; one that needs more stands in blocks of columns below each
/// other, each block with the first column. Without it tables are as wide as they need to be.
void SetTableWidth(std::size_t columns);

}  // namespace fourpost
