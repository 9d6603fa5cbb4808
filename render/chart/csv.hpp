#pragma once

#include <string>

namespace render {

/// Returns the shortest decimal that reads back as the same double, in any locale.
std::string csv_number(double value);

/// Returns a field by RFC 4180: it is quoted if it contains a comma or a quote.
std::string csv_field(const std::string& value);

}  // namespace render
