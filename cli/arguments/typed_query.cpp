#include "cli/arguments/typed_query.hpp"

#include "cli/arguments/car_query.hpp"
#include "cli/arguments/cell_query.hpp"
#include "cli/arguments/planner_argument.hpp"

namespace wend::cli {

std::unique_ptr<TypedQuery> typed_query(const PlannerSpec& planner, const FreeSpace& space,
                                        const Coordinates& coordinates, const EndArguments& ends) {
  if (info_of(planner).motion == Motion::car) {
    return std::make_unique<CarQuery>(space, coordinates, unit_of(planner, coordinates.frame()),
                                      ends);
  }
  return std::make_unique<CellQuery>(space, coordinates, moves_of(planner), ends);
}

}  // namespace wend::cli
