// rejected: mirror
// Arithmetic without a test.
#pragma once
