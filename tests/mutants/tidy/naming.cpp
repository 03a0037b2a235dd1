// rejected: readability-identifier-naming
// Names of another project.
int TwiceAsMuch(int theValue) { return 2 * theValue; }
