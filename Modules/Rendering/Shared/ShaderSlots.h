#ifndef ShaderSlots_h
#define ShaderSlots_h

#include <string>

/// Puts text in place of the line //Hasp::slot of a shader, if it has one.
inline void FillSlot(std::string& shader, const std::string& slot, const std::string& text)
{
  const std::string line = "//Hasp::" + slot;
  const std::size_t at = shader.find(line);
  if (at != std::string::npos)
    shader.replace(at, line.size(), text);
}

#endif
