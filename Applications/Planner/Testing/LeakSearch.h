#pragma once
#include <string>

/// Tokens of the canaries (CanaryFiles.h, and the desk's own) in these bytes: as they are, as
/// UTF-16, in what is compressed in them (zlib, gzip, a zip's entries), and in what pages embed as
/// Base64. Empty: none. Not found: words of a PDF, which are numbers of glyphs there.
std::string LeaksIn(const std::string& bytes);

/// Names of all windows on a display, a line each.
std::string TitlesOn(const std::string& display);
