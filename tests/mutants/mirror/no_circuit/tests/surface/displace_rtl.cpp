// displace: its circuit's test.
