// The file that a picture ends in: PNG or OpenEXR. One thread.
#pragma once
#include "pictures/files/band_file.h"
#include "pictures/picture_options.h"

#include <nlohmann/json.hpp>

#include <string>

namespace gluray::launcher {

/// What rows of pictures are for the file that is asked for: kGlurayBytes ... (saved/program/render.h).
int valuesFor(const PictureOptions& options);

/// A picture whose rows are all in a band file.
struct FinishedPicture {
  const PictureOptions& options;
  const BandFile& bands;
  const std::string& command;   // that makes it again
  const nlohmann::json& facts;  // saved::SavedScene::facts; "hash", "cameras": see rendered_picture.cpp
  const std::string& header;    // of OpenEXR files, from the engine
};

/// Writes the file. Throws std::runtime_error with one line; then a file of that name stays as it was.
void writePicture(const std::string& file, const FinishedPicture& picture);

}  // namespace gluray::launcher
