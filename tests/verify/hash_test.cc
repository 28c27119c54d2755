// A run is repeated when anything changed that its scene names.
#include <gtest/gtest.h>

#include "jobs.h"
#include "workspace.h"

namespace
{
  struct Scene
  {
    Workspace w;
    std::string hash() const { return verify::hash_of_scene((w.root / "scene.toml").string()); }
    /// Does the hash of the scene change with that of `file`?
    bool follows(const std::string &file) const
    {
      const std::string before = hash();
      w.write(file, "changed = 1\n");
      const std::string after = hash();
      EXPECT_EQ(after, hash());
      return before != after;
    }
  };
} // namespace

TEST(HashOfAScene, KnowsEveryFileOfAListOfIncludes)
{
  const Scene scene;
  scene.w.write("a.toml", "a = 1\n");
  scene.w.write("deep/b.toml", "include = 'c.toml'\n");
  scene.w.write("deep/c.toml", "c = 1\n");
  scene.w.write("scene.toml", "include = [\n  \"a.toml\", # first\n  'deep/b.toml',\n]\n");
  EXPECT_TRUE(scene.follows("a.toml"));
  EXPECT_TRUE(scene.follows("deep/c.toml")) << "included by what is included";
  EXPECT_TRUE(scene.follows("deep/b.toml"));
  EXPECT_TRUE(scene.follows("scene.toml"));
}

TEST(HashOfAScene, KnowsTheFileOfABody)
{
  const Scene scene;
  scene.w.write("outline.csv", "0,0\n");
  scene.w.write("other.csv", "0,0\n");
  scene.w.write("scene.toml", "title = \"no file\"\n[[body]]\nfile = \"outline.csv\"\n");
  EXPECT_TRUE(scene.follows("outline.csv"));
  EXPECT_FALSE(scene.follows("other.csv")) << "which it does not name";
}

TEST(HashOfAScene, EndsWhereScenesIncludeEachOther)
{
  const Scene scene;
  scene.w.write("a.toml", "include = \"scene.toml\"\n");
  scene.w.write("scene.toml", "include = \"a.toml\"\n");
  EXPECT_TRUE(scene.follows("a.toml"));
}

TEST(HashOfAScene, KnowsTheFilesThatOverridesName)
{
  const Scene scene;
  scene.w.write("a.csv", "0,0\n");
  scene.w.write("scene.toml", "title = \"t\"\n");
  const auto hash = [&]
  {
    return verify::hash_of_scene((scene.w.root / "scene.toml").string(),
                                 {"body.1.file='a.csv'", "clock.end=1"});
  };
  const std::string before = hash();
  scene.w.write("a.csv", "1,0\n");
  EXPECT_NE(hash(), before);
}
