#pragma once

#include <string>

#include "render/film.hpp"
#include "render/film_options.hpp"

namespace render {

/// What a page that shows the film needs to know, as a JSON object.
std::string film_facts(const Film& film, const FilmOptions& options, int frames);

}  // namespace render
