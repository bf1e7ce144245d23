#pragma once
#include <cstddef>
#include <map>
#include <string>

/// A second reader of .seg.nrrd headers, that shares nothing with the first: fields, pairs with
/// their escapes taken back, and where the samples begin. No checks: it is given sound files.
struct SegmentationText
{
  explicit SegmentationText(const std::string& bytes)
  {
    std::size_t at = bytes.find('\n') + 1; // behind the magic
    for (std::size_t end; (end = bytes.find('\n', at)) != at; at = end + 1)
    {
      const std::string line = bytes.substr(at, end - at);
      const std::size_t pair = line.find(":="), field = line.find(": ");
      if (pair < field)
        this->pairs[line.substr(0, pair)] = Plain(line.substr(pair + 2));
      else
        this->fields[line.substr(0, field)] = line.substr(field + 2);
    }
    this->samples = bytes.substr(at + 1);
    this->magic = bytes.substr(0, bytes.find('\n'));
  }

  static std::string Plain(const std::string& value)
  {
    std::string plain;
    for (std::size_t n = 0; n < value.size(); ++n)
      plain += value[n] != '\\' ? value[n] : value[++n] == 'n' ? '\n' : value[n];
    return plain;
  }

  std::string magic, samples;
  std::map<std::string, std::string> fields, pairs;
};

/// A header of 4 x 3 x 2 samples as 3D Slicer writes it, more lines at its end; layers: as a list.
inline std::string SlicersHeader(const std::string& more, int layers = 0)
{
  const bool list = layers > 0;
  return "NRRD0004\n# Complete NRRD file format specification at:\n"
         "# http://teem.sourceforge.net/nrrd/format.html\n"
         "type: unsigned char\ndimension: " +
         std::string(list ? "4" : "3") +
         "\nspace: left-posterior-superior\nsizes: " + (list ? std::to_string(layers) + " " : "") +
         "4 3 2\nspace directions: " + (list ? "none " : "") +
         "(0.5,0,0) (0,0.75,0) (0,0,2)\nkinds: " + (list ? "list " : "") +
         "domain domain domain\nencoding: raw\nspace origin: (-3,4,5.5)\n" + more + "\n";
}

/// The pairs of a segment as 3D Slicer writes them.
inline std::string SlicersSegment(int n, const std::string& name, int label, int layer)
{
  const std::string key = "Segment" + std::to_string(n) + "_";
  return key + "Color:=0.25 0.5 1\n" + key + "ID:=Segment_" + std::to_string(n + 1) + "\n" + key +
         "LabelValue:=" + std::to_string(label) + "\n" + key + "Layer:=" + std::to_string(layer) +
         "\n" + key + "Name:=" + name + "\n" + key +
         "Tags:=TerminologyEntry:Segmentation category and type~SCT^85756007^Tissue|\n";
}
