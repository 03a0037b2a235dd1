// rejected: clang-format-violations
// Indented by four, as another project would have it.
int twice(int x)
{
    return 2*x;
}
