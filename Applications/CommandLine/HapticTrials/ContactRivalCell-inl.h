// Included where a namespace for one set of flags is open.

namespace
{

struct Corners
{
  float c[8];
  glm::vec3 at;

  float Value() const
  {
    const float low = glm::mix(glm::mix(this->c[0], this->c[1], this->at.x),
      glm::mix(this->c[2], this->c[3], this->at.x), this->at.y);
    const float high = glm::mix(glm::mix(this->c[4], this->c[5], this->at.x),
      glm::mix(this->c[6], this->c[7], this->at.x), this->at.y);
    return glm::mix(low, high, this->at.z);
  }
  glm::vec3 Gradient() const
  {
    const float x = this->at.x, y = this->at.y, z = this->at.z;
    return { glm::mix(glm::mix(this->c[1] - this->c[0], this->c[3] - this->c[2], y),
               glm::mix(this->c[5] - this->c[4], this->c[7] - this->c[6], y), z),
      glm::mix(glm::mix(this->c[2] - this->c[0], this->c[3] - this->c[1], x),
        glm::mix(this->c[6] - this->c[4], this->c[7] - this->c[5], x), z),
      glm::mix(glm::mix(this->c[4] - this->c[0], this->c[5] - this->c[1], x),
        glm::mix(this->c[6] - this->c[2], this->c[7] - this->c[3], x), y) };
  }
};

inline bool Find(const Map& map, const glm::vec3& at, Corners& corners)
{
  const glm::vec3 index = (at - map.origin) * map.perSpacing;
  if (!(index.x >= 0.0F && index.y >= 0.0F && index.z >= 0.0F &&
        index.x < static_cast<float>(map.dims.x - 1) &&
        index.y < static_cast<float>(map.dims.y - 1) &&
        index.z < static_cast<float>(map.dims.z - 1)))
    return false;
  const glm::ivec3 cell(index);
  corners.at = index - glm::vec3(cell);
  const std::size_t row = map.dims.x, slice = row * map.dims.y;
  const float* p = map.mm + cell.z * slice + cell.y * row + cell.x;
  corners.c[0] = p[0];
  corners.c[1] = p[1];
  corners.c[2] = p[row];
  corners.c[3] = p[row + 1];
  corners.c[4] = p[slice];
  corners.c[5] = p[slice + 1];
  corners.c[6] = p[slice + row];
  corners.c[7] = p[slice + row + 1];
  return true;
}

} // namespace
