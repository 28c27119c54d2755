// A short name for what a scene asks for, by which records and checkpoints are told apart.
#pragma once

#include <string>

namespace scene
{
  /// 32 hexadecimal digits of any bytes; FNV-1a, 64 bits from each of two starting values.
  std::string hash_of(const std::string &bytes);
} // namespace scene
