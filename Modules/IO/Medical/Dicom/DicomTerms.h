#pragma once
#include <cstring>

/// The only texts that leave a DICOM file: the decoder maps what the file says onto these, and the
/// reading side takes nothing else from it. So no patient's text can pass, whatever a file says and
/// even if it takes the decoder over.
namespace hasp
{

inline constexpr const char* OtherTerm = "OTHER"; ///< the file says something not listed

/// (0008,0060), the defined terms of PS3.3 C.7.3.1.1.1 that are images or lie beside them.
inline constexpr const char* Modalities[] = { "AR", "ASMT", "AU", "BDUS", "BI", "BMD", "CFM", "CR",
  "CT", "CTPROTOCOL", "DMS", "DG", "DOC", "DX", "ECG", "EEG", "EMG", "EOG", "EPS", "ES", "FID",
  "GM", "HC", "HD", "IO", "IVOCT", "IVUS", "KER", "KO", "LEN", "LS", "M3D", "MG", "MR", "NM", "OAM",
  "OCT", "OP", "OPM", "OPR", "OPT", "OPTBSV", "OPTENF", "OPV", "OSS", "OT", "PA", "PLAN", "POS",
  "PR", "PT", "PX", "REG", "RESP", "RF", "RG", "RTDOSE", "RTIMAGE", "RTINTENT", "RTPLAN", "RTRAD",
  "RTRECORD", "RTSEGANN", "RTSTRUCT", "RWV", "SEG", "SM", "SMR", "SR", "SRF", "STAIN", "TEXTUREMAP",
  "TG", "US", "VA", "XA", "XAPROTOCOL", "XC" };

/// (0028,0004), retired ones too.
inline constexpr const char* Photometrics[] = { "MONOCHROME1", "MONOCHROME2", "PALETTE COLOR",
  "RGB", "HSV", "ARGB", "CMYK", "XYB", "YBR_FULL", "YBR_FULL_422", "YBR_PARTIAL_422",
  "YBR_PARTIAL_420", "YBR_ICT", "YBR_RCT" };

/// (0018,5100): how the patient lay.
inline constexpr const char* PatientPositions[] = { "HFP", "HFS", "HFDR", "HFDL", "FFDR", "FFDL",
  "FFP", "FFS", "LFP", "LFS", "RFP", "RFS", "AFDR", "AFDL", "PFDR", "PFDL" };

struct TransferSyntax
{
  const char* uid;
  const char* name;
  bool decoded = false; ///< by Debian's DCMTK
  bool lossy = false;   ///< pixels are not those that were taken (of JPEG-LS: may not be)
};

/// PS3.6 table A-1, and the one of GE's that files are still found in.
inline constexpr TransferSyntax TransferSyntaxes[] = {
  { "1.2.840.10008.1.2", "Implicit VR Little Endian", true },
  { "1.2.840.10008.1.2.1", "Explicit VR Little Endian", true },
  { "1.2.840.10008.1.2.1.98", "Encapsulated Uncompressed Explicit VR Little Endian" },
  { "1.2.840.10008.1.2.1.99", "Deflated Explicit VR Little Endian", true },
  { "1.2.840.10008.1.2.2", "Explicit VR Big Endian", true },
  { "1.2.840.10008.1.2.4.50", "JPEG Baseline (process 1)", true, true },
  { "1.2.840.10008.1.2.4.51", "JPEG Extended (processes 2 and 4)", true, true },
  { "1.2.840.10008.1.2.4.52", "JPEG Extended, arithmetic (processes 3 and 5)" },
  { "1.2.840.10008.1.2.4.53", "JPEG Spectral Selection (processes 6 and 8)", true, true },
  { "1.2.840.10008.1.2.4.54", "JPEG Spectral Selection, arithmetic (processes 7 and 9)" },
  { "1.2.840.10008.1.2.4.55", "JPEG Full Progression (processes 10 and 12)", true, true },
  { "1.2.840.10008.1.2.4.56", "JPEG Full Progression, arithmetic (processes 11 and 13)" },
  { "1.2.840.10008.1.2.4.57", "JPEG Lossless (process 14)", true },
  { "1.2.840.10008.1.2.4.58", "JPEG Lossless, arithmetic (process 15)" },
  { "1.2.840.10008.1.2.4.59", "JPEG Extended, hierarchical (processes 16 and 18)" },
  { "1.2.840.10008.1.2.4.60", "JPEG Extended, hierarchical, arithmetic (processes 17 and 19)" },
  { "1.2.840.10008.1.2.4.61", "JPEG Spectral Selection, hierarchical (processes 20 and 22)" },
  { "1.2.840.10008.1.2.4.62", "JPEG Spectral Selection, hierarchical, arithmetic (21 and 23)" },
  { "1.2.840.10008.1.2.4.63", "JPEG Full Progression, hierarchical (processes 24 and 26)" },
  { "1.2.840.10008.1.2.4.64", "JPEG Full Progression, hierarchical, arithmetic (25 and 27)" },
  { "1.2.840.10008.1.2.4.65", "JPEG Lossless, hierarchical (process 28)" },
  { "1.2.840.10008.1.2.4.66", "JPEG Lossless, hierarchical, arithmetic (process 29)" },
  { "1.2.840.10008.1.2.4.70", "JPEG Lossless, first-order prediction (process 14)", true },
  { "1.2.840.10008.1.2.4.80", "JPEG-LS Lossless", true },
  { "1.2.840.10008.1.2.4.81", "JPEG-LS Near-Lossless", true, true },
  { "1.2.840.10008.1.2.4.90", "JPEG 2000 (lossless only)" },
  { "1.2.840.10008.1.2.4.91", "JPEG 2000" },
  { "1.2.840.10008.1.2.4.92", "JPEG 2000 Part 2 Multi-component (lossless only)" },
  { "1.2.840.10008.1.2.4.93", "JPEG 2000 Part 2 Multi-component" },
  { "1.2.840.10008.1.2.4.94", "JPIP Referenced" },
  { "1.2.840.10008.1.2.4.95", "JPIP Referenced Deflate" },
  { "1.2.840.10008.1.2.4.100", "MPEG2 Main Profile, Main Level" },
  { "1.2.840.10008.1.2.4.101", "MPEG2 Main Profile, High Level" },
  { "1.2.840.10008.1.2.4.102", "MPEG-4 High Profile, Level 4.1" },
  { "1.2.840.10008.1.2.4.103", "MPEG-4 BD-compatible High Profile, Level 4.1" },
  { "1.2.840.10008.1.2.4.104", "MPEG-4 High Profile, Level 4.2, 2D video" },
  { "1.2.840.10008.1.2.4.105", "MPEG-4 High Profile, Level 4.2, 3D video" },
  { "1.2.840.10008.1.2.4.106", "MPEG-4 Stereo High Profile, Level 4.2" },
  { "1.2.840.10008.1.2.4.107", "HEVC Main Profile, Level 5.1" },
  { "1.2.840.10008.1.2.4.108", "HEVC Main 10 Profile, Level 5.1" },
  { "1.2.840.10008.1.2.4.110", "JPEG XL (lossless)" },
  { "1.2.840.10008.1.2.4.111", "JPEG XL, JPEG recompression" },
  { "1.2.840.10008.1.2.4.112", "JPEG XL" },
  { "1.2.840.10008.1.2.4.201", "High-Throughput JPEG 2000 (lossless only)" },
  { "1.2.840.10008.1.2.4.202", "High-Throughput JPEG 2000 RPCL (lossless only)" },
  { "1.2.840.10008.1.2.4.203", "High-Throughput JPEG 2000" },
  { "1.2.840.10008.1.2.4.204", "JPIP HTJ2K Referenced" },
  { "1.2.840.10008.1.2.4.205", "JPIP HTJ2K Referenced Deflate" },
  { "1.2.840.10008.1.2.5", "RLE Lossless", true },
  { "1.2.840.10008.1.2.7.1", "SMPTE ST 2110-20 Uncompressed Progressive Active Video" },
  { "1.2.840.10008.1.2.7.2", "SMPTE ST 2110-20 Uncompressed Interlaced Active Video" },
  { "1.2.840.10008.1.2.7.3", "SMPTE ST 2110-30 PCM Digital Audio" },
  { "1.2.840.10008.1.2.8.1", "Deflated Image Frame Compression" },
  { "1.2.840.113619.5.2", "GE private, Implicit VR with Big Endian pixels" },
};
inline constexpr TransferSyntax UnknownSyntax = { "", "unknown" };

/// The entry of that UID, else UnknownSyntax.
inline const TransferSyntax& SyntaxOf(const char* uid)
{
  for (const TransferSyntax& syntax : TransferSyntaxes)
    if (std::strcmp(syntax.uid, uid) == 0)
      return syntax;
  return UnknownSyntax;
}

/// The listed term that `text` is; "" for "", OtherTerm for what is not listed.
template <std::size_t N>
const char* TermOf(const char* const (&terms)[N], const char* text)
{
  if (*text == '\0')
    return "";
  for (const char* term : terms)
    if (std::strcmp(term, text) == 0)
      return term;
  return OtherTerm;
}

/// Whether `text` is what TermOf may give.
template <std::size_t N>
bool IsTerm(const char* const (&terms)[N], const char* text)
{
  return std::strcmp(TermOf(terms, text), text) == 0;
}

/// What to do about a series in a syntax of that name that is not decoded.
inline const char* RemedyFor(const char* name)
{
  return std::strncmp(name, "JPEG 2000", 9) == 0
           ? "convert the series first, say with gdcmconv --raw (Debian: libgdcm-tools)"
           : "export the series again uncompressed (Explicit VR Little Endian)";
}

inline bool IsSyntaxName(const char* name)
{
  if (*name == '\0' || std::strcmp(name, UnknownSyntax.name) == 0)
    return true;
  for (const TransferSyntax& syntax : TransferSyntaxes)
    if (std::strcmp(syntax.name, name) == 0)
      return true;
  return false;
}

} // namespace hasp
