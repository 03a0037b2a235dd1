// rejected: mirror
// An entry point without a test.
