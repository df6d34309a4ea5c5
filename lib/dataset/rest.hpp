/// What follows a dataset or a map in its file: nothing, or zeros that pad it.
///
///     cat a.nc b.nc | asperity-stats
///
/// would else measure the first and lose the second without a word.
#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// Throws DataError(variable, …) with the number of bytes unless all of them are zero. Cost: a pass over them.
void refuse_rest(std::string_view rest, const std::string& variable);

}  // namespace asperity
