#pragma once

#include <string>

namespace render {

/// The shortest decimal that reads back as the same double, whatever the locale.
std::string csv_number(double value);

/// A field as RFC 4180 has it: quoted where a comma or a quote stands in it.
std::string csv_field(const std::string& value);

}  // namespace render
