// Repeatable mutations of two whole scenes through the libFuzzer function of scene_fuzz.cc: it
// aborts or crashes where the reader does anything but accept or refuse.
#include <array>
#include <cstdint>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "../scene/scene_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size);

namespace
{
  using Generator = std::mt19937;

  // Pieces at which readers break: brackets, extreme and ill-formed numbers, other encodings.
  const std::array<std::string, 24> pieces{"-",
                                           "[",
                                           "]",
                                           "{",
                                           "}",
                                           "\"",
                                           "=",
                                           ".",
                                           "e300",
                                           "nan",
                                           "inf",
                                           "0",
                                           "-1",
                                           "1e-300",
                                           "\n",
                                           "[[body]]\n",
                                           "[[support]]\n",
                                           "t",
                                           "\\u00e9",
                                           "\xff",
                                           "99999999999999999999",
                                           "1979-05-27",
                                           "#",
                                           "free"};

  void mutate(std::string &text, const std::string &other, Generator &draw)
  {
    const std::size_t at = draw() % (text.size() + 1);
    switch (draw() % 5)
    {
    case 0:
      text.insert(at, pieces[draw() % pieces.size()]);
      break;
    case 1:
      text.erase(at, 1 + draw() % 8);
      break;
    case 2:
      text.insert(at, other.substr(draw() % other.size(), draw() % 60));
      break;
    case 3:
      text.replace(at, 1, 1, static_cast<char>(draw() % 256));
      break;
    default: // another number where one stands
      if (const std::size_t digit = text.find_first_of("0123456789", at);
          digit != std::string::npos)
        text.replace(digit, 1, pieces[8 + draw() % 6]);
    }
  }
} // namespace

TEST(SceneReader, AcceptsOrRefusesWhateverItIsGiven)
{
  Generator draw(20131);
  for (int i = 0; i < 500; ++i)
  {
    std::string text = i % 2 == 0 ? scene_test::bar : scene_test::seed;
    for (unsigned count = 1 + draw() % 4; count > 0; --count)
      mutate(text, i % 2 == 0 ? scene_test::seed : scene_test::bar, draw);
    SCOPED_TRACE(text);
    EXPECT_EQ(
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t *>(text.data()), text.size()),
        0);
  }
}
