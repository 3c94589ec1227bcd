#pragma once

// PlotPage: the gnuplot script of a page of panels, with a headline and a legend above them. The
// caller puts its data and plots in between.

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/plot/plot_style.hpp"

namespace wend {

struct PlotAxis {
  std::string label;
  double unit = 1;  // factor from a value of the measure to the label's unit
  std::string format = "%g";
  bool logarithmic = false;
  double least = 0;
  double greatest = 1;
};

/// In pixels, from the page's bottom left.
struct PlotRectangle {
  double left = 0;
  double bottom = 0;
  double width = 0;
  double height = 0;
};

class PlotPage {
 public:
  static constexpr double kWidth = 1400;  // pixels

  /// `panels` is the height that the panels need; `names` are what is compared.
  PlotPage(PlotKind kind, const PlotColours& colours, std::vector<std::string> names,
           double panels);

  template <class... Values>
  void put(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
  }

  /// Call first: sets terminal, size, colours.
  void put_page();

  void put_panel(const PlotRectangle& place, const PlotAxis& x, const PlotAxis& y);
  void put_axis(char name, const PlotAxis& axis);

  /// Puts the legend and a headline above all panels; every panel shows them until they are unset.
  void put_legend(std::string_view headline);

  /// The style of a name's points and of its lines, for gnuplot's plot.
  std::string point_look(std::size_t name) const;
  std::string line_look(std::size_t name) const;

  std::string take() { return std::move(text_); }

 private:
  double height() const;
  double legend_column() const;
  std::size_t legend_columns() const;
  double legend_rows() const;
  std::string colour_of(std::size_t name) const;

  /// The same size setting gives different sizes in different gnuplot terminals.
  struct Terminal {
    std::string_view name;
    double pixels_per_unit;
    int font;
    int headline_font;
    double mark;
  };

  static Terminal terminal_for(PlotKind kind);

  Terminal terminal_;
  PlotColours colours_;
  std::vector<std::string> names_;
  std::vector<std::size_t> looks_;  // the numbers of their colours and shapes
  double panels_;
  std::string text_;
};

}  // namespace wend
