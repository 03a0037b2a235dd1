// The test is there.
