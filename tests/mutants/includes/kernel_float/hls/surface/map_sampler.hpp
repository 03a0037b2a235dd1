// rejected: float
// A template that no entry point instantiates hides its double from the compiler, not from this gate.
#pragma once

template <class T>
T bilinear(T a, T b, double weight) {
  return static_cast<T>((1.0 - weight) * a + weight * b);
}
