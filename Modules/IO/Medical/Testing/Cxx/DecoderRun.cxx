#include "DecoderRun.h"

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

DecoderAnswer RunDecoder(const std::string& mode, const std::filesystem::path& file,
  const std::filesystem::path& folder, const std::string& locale)
{
  std::ofstream(folder / "list", std::ios::binary) << "0:" + file.string() << '\0';
  const std::string in = folder.string(); // through cat, as the decoder may write no file
  const std::string command = "LC_ALL=" + locale + " '" HASP_DECODER "' " + mode +
                              " 67108864 60 < '" + in + "/list' | cat > '" + in + "/answer'";
  std::string answer;
  if (std::system(command.c_str()) == 0)
  {
    std::ifstream stream(folder / "answer", std::ios::binary);
    answer.assign(std::istreambuf_iterator<char>(stream), {});
  }
  DecoderAnswer parts;
  if (answer.size() >= sizeof(parts.record))
  {
    std::memcpy(&parts.record, answer.data(), sizeof(parts.record));
    parts.pixels = answer.substr(sizeof(parts.record));
  }
  if (answer.size() < sizeof(parts.record) || parts.pixels.size() != parts.record.pixelBytes)
    throw std::runtime_error("the decoder gave no whole answer");
  return parts;
}
