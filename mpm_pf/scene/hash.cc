#include "scene/hash.h"

#include <cstdint>
#include <cstdio>

namespace scene
{
  std::string hash_of(const std::string &bytes)
  {
    std::uint64_t a = 0xcbf29ce484222325ull, b = 0x84222325cbf29ce4ull;
    for (const char c : bytes)
    {
      a = (a ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
      b = (b ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    }
    char hex[33];
    std::snprintf(hex, sizeof hex, "%016llx%016llx", static_cast<unsigned long long>(a),
                  static_cast<unsigned long long>(b));
    return hex;
  }
} // namespace scene
