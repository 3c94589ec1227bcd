#include "bench/plot/plot_page.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wend {
namespace {

constexpr std::array kShapes{7, 5, 9, 13, 11, 6, 4, 8, 12, 10};  // gnuplot's point types
constexpr int kLine = 2;                                         // width

// In pixels.
constexpr double kTitle = 65;
constexpr double kLegendRow = 26;
constexpr double kLegendWidth = 1300;
constexpr double kLetter = 9.7;  // of a name in the legend
constexpr double kMark = 62;     // of an entry, with the space around it

std::string hex(std::uint32_t rgb) { return fmt::format("'#{:06x}'", rgb); }

/// A text in gnuplot's single quotes, on one line.
std::string in_quotes(std::string_view text) {
  std::string quoted = "'";
  for (const char letter : text) {
    const bool is_control = static_cast<unsigned char>(letter) < ' ';
    if (letter == '\'') quoted += '\'';
    quoted += is_control ? ' ' : letter;
  }
  return quoted + "'";
}

}  // namespace

PlotPage::Terminal PlotPage::terminal_for(PlotKind kind) {
  switch (kind) {
    case PlotKind::svg:
      return {"svg", 1, 17, 20, 0.55};
    case PlotKind::pdf:
      return {"pdfcairo", 125, 13, 15, 0.55};
    case PlotKind::png:
      break;
  }
  return {"pngcairo", 1, 13, 15, 0.9};
}

PlotPage::PlotPage(PlotKind kind, const PlotColours& colours, std::vector<std::string> names,
                   double panels)
    : terminal_(terminal_for(kind)),
      colours_(colours),
      names_(std::move(names)),
      looks_(plot_colours_of(names_)),
      panels_(panels) {}

double PlotPage::height() const { return panels_ + kLegendRow * legend_rows() + kTitle; }

double PlotPage::legend_column() const {
  std::size_t longest = 1;
  for (const std::string& name : names_) longest = std::max(longest, name.size());
  return static_cast<double>(longest) * kLetter + kMark;
}

std::size_t PlotPage::legend_columns() const {
  const auto columns = static_cast<std::size_t>(kLegendWidth / legend_column());
  return std::clamp(columns, std::size_t{1}, std::max(names_.size(), std::size_t{1}));
}

double PlotPage::legend_rows() const {
  return std::ceil(static_cast<double>(names_.size()) / static_cast<double>(legend_columns()));
}

void PlotPage::put_page() {
  const std::string page = hex(colours_.page);
  const std::string ink = hex(colours_.ink);
  const bool in_inches = terminal_.pixels_per_unit != 1;
  put("set encoding utf8\nset terminal {} noenhanced background {} font 'sans,{}' ", terminal_.name,
      page, terminal_.font);
  put("size {0:.{2}f}{3},{1:.{2}f}{3}\n", kWidth / terminal_.pixels_per_unit,
      height() / terminal_.pixels_per_unit, in_inches ? 2 : 0, in_inches ? "in" : "");
  put("set border 3 lw 1 lc rgb {}\nset tics nomirror out textcolor rgb {}\n", ink, ink);
  put("set grid lw 1 lt 1 lc rgb {}\nset style data points\n", hex(colours_.grid));
}

void PlotPage::put_panel(const PlotRectangle& place, const PlotAxis& x, const PlotAxis& y) {
  put("set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\n", place.left / kWidth,
      (place.left + place.width) / kWidth);
  put("set bmargin at screen {:.4f}\nset tmargin at screen {:.4f}\n", place.bottom / height(),
      (place.bottom + place.height) / height());
  put_axis('x', x);
  put_axis('y', y);
}

void PlotPage::put_axis(char name, const PlotAxis& axis) {
  put("set {}label {} textcolor rgb {}\n", name, in_quotes(axis.label), hex(colours_.ink));
  put("{} logscale {}\n", axis.logarithmic ? "set" : "unset", name);
  put("set format {} '{}'\n", name, axis.format);
  put("set {}range [{}:{}]\n", name, axis.least, axis.greatest);
}

void PlotPage::put_legend(std::string_view headline) {
  const std::string ink = hex(colours_.ink);
  put("set label {} at screen 0.5,{:.4f} center font ',{}' textcolor rgb {}\n", in_quotes(headline),
      1 - 26 / height(), terminal_.headline_font, ink);
  const std::size_t columns = legend_columns();
  const double left = (kWidth - legend_column() * static_cast<double>(columns) + kMark) / 2;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const std::size_t row = i / columns;
    const double x = left + legend_column() * static_cast<double>(i % columns);
    const double y = height() - kTitle - kLegendRow * static_cast<double>(row);
    put("set label {} at screen {:.4f},{:.4f} left offset 1.2,0 textcolor rgb {} point {}\n",
        in_quotes(names_[i]), x / kWidth, y / height(), ink, point_look(i));
  }
}

std::string PlotPage::colour_of(std::size_t name) const {
  return hex(colours_.names[looks_[name]]);
}

std::string PlotPage::point_look(std::size_t name) const {
  return fmt::format("pt {} ps {} {}", kShapes[looks_[name] % kShapes.size()], terminal_.mark,
                     line_look(name));
}

std::string PlotPage::line_look(std::size_t name) const {
  return fmt::format("lw {} lc rgb {}", kLine, colour_of(name));
}

}  // namespace wend
