// SPDX-License-Identifier: MIT
#include <cairo.h>

#include "draw/strip_support.hpp"
#include "support/person_file.hpp"
#include "support/run_program.hpp"
#include "support/work_folder.hpp"

namespace shigusa {
namespace {

using namespace strip_support;
using namespace testing_support;

constexpr double kPixels = 300.0 / 72.0;  // a point

// A colour's pixels in a PNG, and their extent in points.
class Pixels {
 public:
  explicit Pixels(const std::string& png)
      : surface_(cairo_image_surface_create_from_png(png.c_str())) {}
  Pixels(const Pixels&) = delete;
  ~Pixels() { cairo_surface_destroy(surface_); }

  [[nodiscard]] int width() const { return cairo_image_surface_get_width(surface_); }
  [[nodiscard]] int height() const { return cairo_image_surface_get_height(surface_); }

  // Of the pixels of a colour between two heights.
  [[nodiscard]] Path box_of(std::uint32_t colour, double top, double bottom) const {
    const auto* data =
        reinterpret_cast<const std::uint32_t*>(cairo_image_surface_get_data(surface_));
    const int stride = cairo_image_surface_get_stride(surface_) / 4;
    Path box;
    for (int y = 0; y < height(); ++y) {
      if (y < kPixels * top || y > kPixels * bottom) continue;
      for (int x = 0; x < width(); ++x) {
        if ((data[y * stride + x] & 0xffffff) == colour) box.add(x / kPixels, y / kPixels);
      }
    }
    return box;
  }

 private:
  cairo_surface_t* surface_;
};

class Picture : public testing::Test {
 protected:
  Picture() {
    work_.put("person.bvh", person_bvh());
    for (const char* name : {"a.svg", "a.png", "a.pdf"}) {
      const ProgramRun run =
          run_shigusa({"render", "person.bvh", "--out", name}, {.folder = work_.path()});
      EXPECT_EQ(run.exit_code, 0) << run.err;
    }
    svg_ = work_.get("a.svg");
  }

  WorkFolder work_;
  std::string svg_;
};

TEST_F(Picture, PngHas300PixelsAnInch) {
  const Pixels png(work_ / "a.png");
  const std::string page = svg_.substr(svg_.find("<svg"));
  EXPECT_NEAR(png.width(), kPixels * attribute(page, "width"), 0.51);
  EXPECT_NEAR(png.height(), kPixels * attribute(page, "height"), 0.51);
}

TEST_F(Picture, PngShowsTheFiguresOfTheSvg) {
  const std::vector<Path> arms = filled(svg_, kAccent);
  ASSERT_FALSE(arms.empty());
  Path expected;
  for (const Path& arm : arms) {
    expected.add(arm.left(), arm.top());
    expected.add(arm.right(), arm.bottom());
  }
  const Path seen = Pixels(work_ / "a.png").box_of(0xa32b19, 0.0, 1e9);
  EXPECT_NEAR(seen.left(), expected.left(), kLineSlack);
  EXPECT_NEAR(seen.right(), expected.right(), kLineSlack);
  EXPECT_NEAR(seen.top(), expected.top(), kLineSlack);
  EXPECT_NEAR(seen.bottom(), expected.bottom(), kLineSlack);
}

TEST_F(Picture, PngHasTextsAtTheWidthThatTheSvgAsksFor) {
  const std::vector<Words> all = words(svg_);
  ASSERT_GT(all.size(), 2u);
  const double base = all.front().base;  // of the times
  const Path seen = Pixels(work_ / "a.png").box_of(0x2f3942, base - 6.0, base + 1.0);
  double right = 0.0;
  for (const Words& time : all) right = time.base == base ? std::max(right, time.right) : right;
  EXPECT_NEAR(seen.left(), all.front().left, kLineSlack);
  EXPECT_NEAR(seen.right(), right, kLineSlack);
}

TEST_F(Picture, PdfIsAPageOfTheSvgsSizeInCurves) {
  const std::string pdf = work_.get("a.pdf");
  const std::string page = svg_.substr(svg_.find("<svg"));
  const std::size_t box = pdf.find("/MediaBox [ 0 0 ");
  ASSERT_NE(box, pdf.npos);
  const char* size = pdf.c_str() + box + 16;
  EXPECT_NEAR(take_number(size), attribute(page, "width"), 0.01);
  EXPECT_NEAR(take_number(size), attribute(page, "height"), 0.01);
  EXPECT_EQ(pdf.find("/Image"), pdf.npos);
}

}  // namespace
}  // namespace shigusa
