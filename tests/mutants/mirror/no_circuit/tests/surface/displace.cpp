// displace: its test.
