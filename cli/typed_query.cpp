#include "typed_query.hpp"

#include "cell_query.hpp"
#include "planner_argument.hpp"

namespace wend::cli {

std::unique_ptr<TypedQuery> typed_query(const PlannerSpec& planner, const FreeSpace& space,
                                        const Coordinates& coordinates, const EndArguments& ends) {
  return std::make_unique<CellQuery>(space, coordinates, moves_of(planner), ends);
}

}  // namespace wend::cli
