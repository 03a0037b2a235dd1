// rejected: mirror
// A kernel without a definition.
#pragma once
