#pragma once

#include <string>

#include "render/film/film.hpp"
#include "render/film/film_options.hpp"

namespace render {

/// Returns a JSON object with everything that a page needs to show the film.
std::string film_facts(const Film& film, const FilmOptions& options, int frames);

}  // namespace render
