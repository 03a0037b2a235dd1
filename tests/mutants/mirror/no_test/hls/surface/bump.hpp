// rejected: mirror
// A kernel and its definition without a test.
#pragma once
