// What scripts/budgets compiles to learn how fast the machine is: it never changes, and includes nothing of wend.
#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <regex>
#include <string>
#include <tuple>
#include <unordered_map>
#include <variant>
#include <vector>

template <int N>
struct Step {
  using Key = std::tuple<std::string, int, std::integral_constant<int, N>>;
  static std::size_t run(const std::vector<std::string>& words) {
    std::map<std::string, std::variant<int, std::string, std::vector<Step>>> kept;
    std::unordered_map<std::string, std::function<std::size_t(const Step&)>> calls;
    std::vector<std::pair<std::string, Step>> order;
    for (const std::string& word : words) {
      kept[word] = N;
      calls[word] = [&](const Step&) { return kept.size(); };
      order.emplace_back(word, Step{});
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::size_t sum = order.size();
    for (const auto& [word, call] : calls) sum += call(Step{}) + word.size();
    return sum + Step<N - 1>::run(words);
  }
};

template <>
struct Step<0> {
  static std::size_t run(const std::vector<std::string>& words) { return words.size(); }
};

int main(int count, char** arguments) {
  const std::vector<std::string> words(arguments, arguments + count);
  const std::regex digits("[0-9]+");
  const bool found = std::any_of(words.begin(), words.end(),
                                 [&](const auto& word) { return std::regex_search(word, digits); });
  std::cout << Step<4>::run(words) << found << '\n';
}
