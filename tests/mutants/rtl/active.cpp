// The mutant that the environment switches on, as the woven circuits ask for it when a model is constructed; 0: none.
#include <cstdlib>

extern "C" int relievo_active_mutant();
int relievo_active_mutant() {
  char const* const number = std::getenv("RELIEVO_MUTANT");
  return number == nullptr ? 0 : std::atoi(number);
}
