// memory_pkg: a package alone.
