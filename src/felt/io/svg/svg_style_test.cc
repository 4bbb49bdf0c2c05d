#include "felt/io/svg/svg_style.h"

#include <gtest/gtest.h>

#include <pugixml.hpp>

#include "felt/io/svg/svg_css.h"

namespace felt::svg_style_test {
namespace {

/// Returns the fill of the element with the id "t" of a document.
std::string fill_of(const std::string& css, const std::string& xml) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_string(xml.c_str()));
  SvgStyleSheet style_sheet;
  style_sheet.add(css);
  const pugi::xml_node node = document.find_node(
      [](const auto& n) { return std::string(n.attribute("id").value()) == "t"; });
  SvgDeclared declared;
  std::string clean;
  EXPECT_TRUE(svg_declared(node, style_sheet, clean, declared));
  return std::string(declared[SvgProperty::kFill]);
}

TEST(SvgCss, SelectorsFindTheirElements) {
  const std::string xml =
      "<svg><g class='a b'><defs/><path/><rect id='t' class='x  y' k='v-w'/>"
      "<line/></g></svg>";
  for (const char* yes : {"rect",
                          "*",
                          "#t",
                          ".x",
                          ".y",
                          ".y.x",
                          "rect#t.x",
                          "g rect",
                          "g > rect",
                          "svg rect",
                          "svg>g>rect",
                          "path + rect",
                          "defs ~ rect",
                          "path~rect",
                          "[k]",
                          "[k=v-w]",
                          "[k='v-w']",
                          "[k|=v]",
                          "[k^=v]",
                          "[k$='w']",
                          "[k*='-']",
                          "[class~=y]",
                          "svg .b > .x",
                          "a, rect",
                          "svg|rect",
                          ":root rect",
                          "g:first-child > rect",
                          "svg g.a.b path + rect.x"}) {
    EXPECT_EQ(fill_of(std::string(yes) + "{fill:red}", xml), "red") << yes;
  }
  for (const char* no : {"path",
                         "#u",
                         ".z",
                         ".x.z",
                         "rect > g",
                         "svg > rect",
                         "defs + rect",
                         "line ~ rect",
                         "[k=v]",
                         "[q]",
                         ":first-child",
                         "rect:hover",
                         "rect::before",
                         "rect:not(.x)",
                         "g:last-child rect path",
                         ".x .y",
                         "rect rect",
                         "> rect",
                         "rect >",
                         ":nth-child(2)",
                         ""}) {
    EXPECT_EQ(fill_of(std::string(no) + "{fill:red}", xml), "") << no;
  }
}

TEST(SvgCss, WhatWins) {
  const auto fill = [](const char* css, const char* attributes) {
    return fill_of(css, "<svg><rect id='t' class='a' " + std::string(attributes) + "/></svg>");
  };
  EXPECT_EQ(fill("rect{fill:red}", "fill='blue'"), "red");
  EXPECT_EQ(fill("rect{fill:red}", "style='fill:blue'"), "blue");
  EXPECT_EQ(fill("rect{fill:red!important}", "style='fill:blue'"), "red");
  EXPECT_EQ(fill("rect{fill:red!important}", "style='fill:blue ! important'"), "blue");
  EXPECT_EQ(fill(".a{fill:red} rect{fill:blue}", ""), "red");
  EXPECT_EQ(fill("#t{fill:red} .a.a{fill:blue}", ""), "red");
  EXPECT_EQ(fill("rect{fill:red} rect{fill:blue}", ""), "blue");
  EXPECT_EQ(fill("rect{fill:red;fill:nonsense}", ""), "red");
  EXPECT_EQ(fill("rect{fill:red} /* rect{fill:blue} */", ""), "red");
  EXPECT_EQ(fill("@import 'x'; @media print{rect{fill:blue}} rect{fill:red}", ""), "red");
  EXPECT_EQ(fill("rect{fill:red", ""), "red");
  EXPECT_EQ(fill("<!-- rect{fill:red} -->", ""), "red");
}

TEST(SvgCss, HostileRulesEnd) {
  std::string xml, css;
  for (int i = 0; i < 200; ++i) xml += "<g>";
  xml += "<rect id='t'/>";
  for (int i = 0; i < 200; ++i) xml += "</g>";
  for (int i = 0; i < 60; ++i) css += "g ";
  css += "x rect{fill:red}";
  css = "q " + css;
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(xml.c_str()));
  SvgStyleSheet style_sheet;
  style_sheet.add(css);
  SvgDeclared declared;
  std::string clean;
  const pugi::xml_node node =
      document.find_node([](const auto& n) { return std::string(n.name()) == "rect"; });
  static_cast<void>(svg_declared(node, style_sheet, clean, declared));
  style_sheet.add("q" + css);
  style_sheet.add("g g g g g g g g g g g g g g g g g g g g q>g rect{fill:red}");
  for (int i = 0; i < 3; ++i) static_cast<void>(svg_declared(node, style_sheet, clean, declared));
  EXPECT_EQ(declared[SvgProperty::kFill], "");
}

TEST(SvgColor, AllForms) {
  const Rgba orange{255, 136, 0, 255};
  for (const char* text :
       {"#f80", "#FF8800", "#f80f", "#ff8800ff", "rgb(255,136,0)", "rgb( 255 136 0 )",
        "rgb(255 136 0 / 1)", "rgba(255,136,0,100%)", " rgb(100%,53.4%,0%) ", "hsl(32,100%,50%)",
        "hsl(392 100% 50%)", "hsla(32deg,100%,50%,1)", "#f80 icc-color(x, 1)"}) {
    EXPECT_EQ(svg_color(text), orange) << text;
  }
  EXPECT_EQ(svg_color("CornflowerBlue"), (Rgba{100, 149, 237, 255}));
  EXPECT_EQ(svg_color("transparent")->a, 0);
  EXPECT_EQ(svg_color("rgba(300,-3,0,.5)"), (Rgba{255, 0, 0, 128}));
  for (const char* bad : {"", "#12", "#12345", "#ggg", "rgb(1,2)", "rgb(1,2,3", "rgb(1,2%,3)",
                          "hsl(1,2,3)", "nocolour", "red blue", "rgb(1,2,3,4,5)"}) {
    EXPECT_FALSE(svg_color(bad)) << bad;
  }
}

TEST(SvgColor, Paints) {
  using Kind = SvgPaint::Kind;
  EXPECT_EQ(svg_paint("none")->kind, Kind::kNone);
  EXPECT_EQ(svg_paint("currentcolor")->kind, Kind::kCurrent);
  EXPECT_EQ(svg_paint("url(#a)")->server, "a");
  EXPECT_EQ(svg_paint("url( '#a b' ) red")->server, "a b");
  EXPECT_EQ(svg_paint("url(#a) red")->fallback, Kind::kColor);
  EXPECT_EQ(svg_paint("url(#a) none")->fallback, Kind::kNone);
  EXPECT_EQ(svg_paint("url(other.svg#a)")->server, "");
  EXPECT_FALSE(svg_paint("url"));
  EXPECT_EQ(svg_share("50%"), 0.5);
  EXPECT_EQ(svg_share("-3"), 0.0);
  EXPECT_FALSE(svg_share("half"));
}

TEST(SvgStyle, InheritsAndComputes) {
  const auto style = [](SvgProperty p, const char* value, const SvgStyle& parent = {}) {
    SvgDeclared declared;
    declared.set(p, value);
    return svg_style(declared, parent, SvgUnits{});
  };
  const SvgStyle wide = style(SvgProperty::kStrokeWidth, "5");
  EXPECT_EQ(style(SvgProperty::kFill, "red", wide).stroke_width, 5.0);
  EXPECT_EQ(style(SvgProperty::kStrokeWidth, "initial", wide).stroke_width, 1.0);
  EXPECT_EQ(style(SvgProperty::kStrokeWidth, "inherit", wide).stroke_width, 5.0);
  EXPECT_EQ(style(SvgProperty::kStrokeWidth, "-2", wide).stroke_width, 5.0);
  EXPECT_EQ(style(SvgProperty::kOpacity, "0.5").opacity, 0.5);
  EXPECT_EQ(style(SvgProperty::kFill, "red", style(SvgProperty::kOpacity, "0.5")).opacity, 1.0);
  EXPECT_EQ(*style(SvgProperty::kStrokeDasharray, "3 4 5").dashes,
            (std::vector<double>{3, 4, 5, 3, 4, 5}));
  for (const char* solid : {"none", "0", "0 0", "3 -1", "x"}) {
    EXPECT_EQ(style(SvgProperty::kStrokeDasharray, solid).dashes, nullptr) << solid;
  }
  EXPECT_EQ(*style(SvgProperty::kStrokeDasharray, "4 0").dashes, (std::vector<double>{4, 0}));
  EXPECT_EQ(style(SvgProperty::kFontSize, "150%").font_size, 24.0);
  EXPECT_EQ(style(SvgProperty::kFontSize, "large").font_size, 18.0);
}

}  // namespace
}  // namespace felt::svg_style_test
