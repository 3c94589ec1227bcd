#include "cli/commands/explain_drive.hpp"

#include <fmt/format.h>

#include "cli/arguments/typed_request.hpp"
#include "cli/output/explanations.hpp"
#include "cli/output/query_scene.hpp"
#include "cli/output/terminal.hpp"
#include "wend/analysis/no_drive.hpp"
#include "wend/report/analysis_report.hpp"

namespace wend::cli {
namespace {

HybridAStarOptions options_of(const PlannerSpec& planner) {
  auto options = parse_options<HybridAStarOptions>(planner.options);
  if (!options) throw InputError(options.error().message);
  return *options;
}

class DriveAnswer {
 public:
  DriveAnswer(const DriveQuestion& question, const FreeSpace& space, const Coordinates& coordinates)
      : question_(question),
        space_(space),
        coordinates_(coordinates),
        explainer_(explainer_for(space, coordinates, {})),
        request_(
            typed_request(question.planner, space, coordinates, {question.start, {question.goal}})),
        query_(query_of(request_, space.map().frame())) {
    auto why = explain_no_drive(space, query_, options_of(question.planner));
    if (!why) throw InputError(why.error().message);
    why_ = *std::move(why);
    const EndTexts& ends = request_.texts;
    if (why_.status == Status::start_outside) {
      throw InputError(explainer_.outside({"start", {}, ends.start}));
    }
    if (why_.status == Status::goal_outside) {
      throw InputError(explainer_.outside({"goal", {}, ends.goals.front()}));
    }
  }

  bool drive_exists() const { return why_.drive_exists(); }
  std::string json() const { return no_drive_json(why_, space_); }
  std::string text() const;
  Scene scene() const;

 private:
  std::string headline() const;
  std::string narrowest() const;

  const DriveQuestion& question_;
  const FreeSpace& space_;
  const Coordinates& coordinates_;
  Explainer explainer_;
  PlanRequest request_;
  Query query_;
  NoDrive why_;
};

std::string DriveAnswer::headline() const {
  const EndTexts& ends = request_.texts;
  const std::string between =
      fmt::format("from start {} to goal {}", ends.start, ends.goals.front());
  if (drive_exists()) return folded("there is a drive " + between, detect_screen().columns) + "\n";
  const char* found = why_.certain ? "there is no drive " : "found no drive ";
  return folded(found + between, detect_screen().columns) + "\n";
}

std::string DriveAnswer::narrowest() const {
  if (!why_.widest) return "none, even for a point";
  const std::string disc = "a disc " + explainer_.width(*why_.widest);
  if (!space_.footprint().covers_base_point()) {
    return disc + "; the robot's base point lies outside its footprint, so a narrower way may do";
  }
  return disc + "; the largest disc within the robot has " +
         coordinates_.length(space_.inscribed_radius_in_cells());
}

std::string DriveAnswer::text() const {
  std::string text = headline();
  text += picture(scene(), detect_screen(), question_.pictures);
  if (!drive_exists()) {
    text += explanation_line("reason", explainer_.words(why_.failure));
  }
  text += explanation_line("widest path", narrowest());
  if (drive_exists()) return text;
  const auto changes = explainer_.changes(why_);
  for (const std::string& change : changes) text += explanation_line("would help", change);
  if (changes.empty()) text += explanation_line("would help", "nothing that was tried");
  return text;
}

Scene DriveAnswer::scene() const {
  Scene scene = query_scene(request_.planner, space_, query_);
  if (why_.widest && !why_.widest->path.empty()) {
    scene.lines.push_back(
        {LineRole::possible, why_.widest->path.points(), "widest path of a disc"});
    scene.narrowest = why_.widest->narrowest;
  }
  return scene;
}

}  // namespace

ExitCode explain_drive(const DriveQuestion& question, const FreeSpace& space,
                       const Coordinates& coordinates) {
  const DriveAnswer answer(question, space, coordinates);
  print(question.format == Format::json ? answer.json() : answer.text());
  auto writers = picture_writers({{{}, answer.scene(), {}}}, question.pictures.style);
  writers[".json"] = [&](const std::string& file) { return write_bytes(file, answer.json()); };
  question.output.write(writers);
  return answer.drive_exists() ? success : no_plan;
}

}  // namespace wend::cli
