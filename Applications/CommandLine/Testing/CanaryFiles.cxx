#include "CanaryFiles.h"
#include "ZipFile.h"

#include "vtk_zlib.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace canary
{
namespace
{

std::string Gzip(const std::string& bytes)
{
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, bytes.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string TarEntry(const std::string& name, const std::string& bytes)
{
  std::string header(512, '\0');
  header.replace(0, name.size(), name);
  header.replace(100, 7, "0000644");
  header.replace(108, 7, "0000000").replace(116, 7, "0000000").replace(136, 11, "00000000000");
  char size[12];
  std::snprintf(size, sizeof size, "%011zo", bytes.size());
  header.replace(124, 11, size);
  header[156] = '0';
  header.replace(257, 8, std::string("ustar\0", 6) + "00");
  header.replace(265, Family.size(), Family).replace(297, Given.size(), Given); // owner, group
  header.replace(148, 8, 8, ' ');
  unsigned sum = 0;
  for (const unsigned char c : header)
    sum += c;
  char check[8];
  std::snprintf(check, sizeof check, "%06o", sum);
  header.replace(148, 7, std::string(check) + '\0');
  return header + bytes + std::string((512 - bytes.size() % 512) % 512, '\0');
}

std::string Inv3(const std::string& modality)
{
  const std::string samples = Name() + ".dat",
                    list = R"(<?xml version="1.0" encoding="UTF-8"?><!-- )" + Name() +
                           R"( --><plist version="1.0"><dict><key>name</key><string>)" + Family +
                           "^" + Given + "</string><key>" + Name() + "</key><string>" + Name() +
                           R"(</string><key>matrix</key><dict><key>dtype</key><string>int16</string>
<key>filename</key><string>)" +
                           samples + R"(</string><key>shape</key><array><integer>8</integer>
<integer>8</integer><integer>8</integer></array></dict><key>modality</key><string>)" +
                           modality + R"(</string><key>orientation</key><integer>1</integer>
<key>spacing</key><array><real>2</real><real>2</real><real>2</real></array></dict></plist>)";
  return Gzip(TarEntry(Name() + "/main.plist", list) + TarEntry(Name() + "/" + samples, Ball()) +
              TarEntry(Name() + "/" + Given + ".plist", list) + std::string(1024, '\0'));
}

std::string Mha()
{
  return "ObjectType = Image\nNDims = 3\nComment = " + Family + " " + Given +
         "\nID = 7\nName = " + Name() + "\nPatientName = " + Family + "^" + Given + "\n" + Given +
         " = " + Family +
         "\nBinaryData = True\nBinaryDataByteOrderMSB = False\nDimSize = 8 8 8\n"
         "ElementSpacing = 2 2 2\nElementType = MET_SHORT\n";
}

std::string Nrrd(const std::string& type, const std::string& more)
{
  return "NRRD0005\n# " + Name() + "\ncontent: " + Name() + "\ntype: " + type +
         "\ndimension: 3\nspace: left-posterior-superior\nsizes: 8 8 8\n"
         "space directions: (2,0,0) (0,2,0) (0,0,2)\nkinds: domain domain domain\n"
         "endian: little\nencoding: raw\nspace origin: (0,0,0)\n" +
         Family + ":=" + Given + "\npatient:=" + Name() + "\n" + more;
}

std::string Nii()
{
  std::string header(352, '\0');
  const auto put = [&](std::size_t at, auto value)
  { std::memcpy(header.data() + at, &value, sizeof value); };
  put(0, std::int32_t(348));
  for (const auto& [at, text] : std::vector<std::pair<std::size_t, std::string>>{ { 4, Family },
         { 14, Given }, { 148, Name() + " " + Number }, { 228, Name() }, { 328, Family } })
    header.replace(at, text.size(), text); // data type, db name, description, aux file, intent
  for (int n = 0; n < 8; ++n)
    put(40 + 2 * n, std::int16_t(n == 0 ? 3 : n < 4 ? 8 : 1));
  put(70, std::int16_t(4)); // int16
  put(72, std::int16_t(16));
  for (int n = 0; n < 4; ++n)
    put(76 + 4 * n, n == 0 ? 1.0F : 2.0F);
  put(108, 352.0F);
  put(112, 1.0F);
  header[123] = 2; // mm
  put(254, std::int16_t(1));
  for (int row = 0; row < 3; ++row)
    put(280 + 16 * row + 4 * row, row == 2 ? 2.0F : -2.0F);
  header.replace(344, 3, "n+1");
  return header + Ball();
}

std::string Vti(const std::string& array)
{
  std::string values;
  const std::string ball = Ball();
  for (std::size_t n = 0; n < ball.size(); n += 2)
  {
    std::int16_t value = 0;
    std::memcpy(&value, ball.data() + n, 2);
    values += std::to_string(value) + " ";
  }
  return R"(<?xml version="1.0"?><!-- )" + Name() +
         R"( --><VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<ImageData WholeExtent="0 7 0 7 0 7" Origin="0 0 0" Spacing="2 2 2"><FieldData>
<Array type="String" Name=")" +
         Name() +
         R"(" NumberOfTuples="1" format="ascii">113 122 118 107 101 114 105 107 97 0</Array>
</FieldData><Piece Extent="0 7 0 7 0 7"><PointData Scalars=")" +
         array + R"("><DataArray type="Int16" Name=")" + array + R"(" format="ascii">)" + values +
         "</DataArray></PointData></Piece></ImageData></VTKFile>";
}

} // namespace

std::string Ball()
{
  std::string bytes;
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 8; ++j)
      for (int i = 0; i < 8; ++i)
      {
        const double x = i - 3.4, y = j - 3.5, z = k - 3.6;
        const std::int16_t value = x * x + y * y + z * z < 7.5 ? 300 : -1000;
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
      }
  return bytes;
}

void WriteTo(const std::filesystem::path& file, const std::string& bytes)
{
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

std::vector<Input> MakeVolumes(const std::filesystem::path& folder)
{
  std::vector<Input> inputs;
  const auto add = [&](const std::string& name, const std::string& bytes, bool opens = true)
  {
    WriteTo(folder / name, bytes);
    inputs.push_back({ (folder / name).string(), opens });
  };
  const std::string name = Name();
#if HASP_WITH_LIBARCHIVE
  add(name + ".inv3", Inv3("CT"));
  add(name + "2.inv3", Inv3(Family));
#endif
  add(name + ".mha", Mha() + "ElementDataFile = LOCAL\n" + Ball());
  WriteTo(folder / (name + ".raw"), Ball());
  add(name + ".mhd", Mha() + "ElementDataFile = " + name + ".raw\n");
  add(name + "3.mhd", Mha() + "ElementDataFile = " + Given + ".raw\n", false);
  add(name + ".nrrd", Nrrd("short", "\n") + Ball());
  add(name + ".seg.nrrd",
    Nrrd("uchar", "Segment0_ID:=" + Family + "\nSegment0_Name:=" + Family + " " + Given +
                    "\nSegment0_LabelValue:=1\nSegment0_Layer:=0\nSegment0_Tags:=" + Name() +
                    "\n\n") +
      std::string(300, '\0') + std::string(212, '\1'));
  add(name + ".nii", Nii());
  add(name + ".nii.gz", Gzip(Nii()));
  add(name + ".vti", Vti(name));
  add(Given + Number + "." + Family, "text of " + Name(), false); // an ending that is a name
  return inputs;
}

std::vector<Input> MakeSurfaces(const std::filesystem::path& folder)
{
  std::vector<Input> inputs;
  const auto add = [&](const std::string& ending, const std::string& bytes)
  {
    WriteTo(folder / (Name() + ending), bytes);
    inputs.push_back({ (folder / (Name() + ending)).string() });
  };
  std::string binary = "Hasp " + Name() + " " + Number;
  binary.resize(80, ' ');
  const std::uint32_t one = 1;
  const std::array<float, 12> triangle{ 0, 0, 1, 0, 0, 0, 9, 0, 0, 0, 9, 0 };
  binary.append(reinterpret_cast<const char*>(&one), 4);
  binary.append(reinterpret_cast<const char*>(triangle.data()), sizeof triangle);
  add(".stl", binary + std::string(2, '\0'));
  add("2.stl", "solid " + Name() +
                 "\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 9 0 0\nvertex 0 9 0\n"
                 "endloop\nendfacet\nendsolid " +
                 Name() + "\n");
  add(".ply", "ply\nformat ascii 1.0\ncomment " + Name() + "\nobj_info " + Name() +
                "\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                "0 0 0\n9 0 0\n0 9 0\n3 0 1 2\n");
  add(".obj", "# " + Name() + "\nmtllib " + Name() + ".mtl\no " + Family + "\ng " + Given +
                "\nusemtl " + Name() + "\nv 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n");
  add(".vtp", R"(<?xml version="1.0"?><!-- )" + Name() +
                R"( --><VTKFile type="PolyData" version="1.0" byte_order="LittleEndian">
<PolyData><Piece NumberOfPoints="3" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0"
NumberOfPolys="1"><PointData><DataArray type="Float32" Name=")" +
                Name() + R"(" format="ascii">1 2 3</DataArray></PointData><Points>
<DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 9 0 0 0 9 0</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">3</DataArray></Polys></Piece></PolyData></VTKFile>)");
  const std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?><!-- " + Name() + " -->";
  const std::string packages = "http://schemas.openxmlformats.org/package/2006/";
  const std::string model = "http://schemas.microsoft.com/3dmanufacturing/";
  add(".3mf",
    ZipFile({
      { "[Content_Types].xml", xml + "<Types xmlns=\"" + packages +
                                 "content-types\"><Default Extension=\"rels\" "
                                 "ContentType=\"application/"
                                 "vnd.openxmlformats-package.relationships+xml\"/><Default "
                                 "Extension=\"model\" ContentType=\"application/"
                                 "vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>" },
      { "_rels/.rels",
        xml + "<Relationships xmlns=\"" + packages + "relationships\"><Relationship Target=\"/3D/" +
          Family + ".model\" Id=\"rel0\" Type=\"" + model + "2013/01/3dmodel\"/></Relationships>" },
      { "3D/" + Family + ".model",
        xml + "<model unit=\"millimeter\" xml:lang=\"en-US\" xmlns=\"" + model +
          "core/2015/02\"><metadata name=\"Title\">" + Name() +
          "</metadata><metadata name=\"Description\">Hasp 1 SPACE=LPS; PART=" + Name() +
          "</metadata><metadata name=\"Designer\">" + Name() +
          "</metadata><resources><object id=\"1\" type=\"model\" name=\"" + Name() +
          "\" partnumber=\"" + Number +
          "\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"9\" y=\"0\" z=\"0\"/>"
          "<vertex x=\"0\" y=\"9\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"9\"/></vertices>"
          "<triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/>"
          "<triangle v1=\"1\" v2=\"2\" v3=\"3\"/><triangle v1=\"0\" v2=\"3\" v3=\"2\"/>"
          "</triangles></mesh></object></resources><build><item objectid=\"1\" partnumber=\"" +
          Number + "\"/></build></model>" },
    }));
  return inputs;
}

} // namespace canary
