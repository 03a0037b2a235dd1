// displace: the golden twin.
