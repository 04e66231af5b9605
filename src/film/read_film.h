// Reads what film_part.h describes.
#pragma once
#include <filesystem>

#include "film/film_record.h"

namespace vkpt {

/// The part vkpt.film of an EXR file; no other part is read. Throws FileError where there is no such file or part, or
/// it is damaged or of another version. Allocates no more than the file can hold.
[[nodiscard]] FilmRecord readFilm(const std::filesystem::path& path);

}  // namespace vkpt
