// displace: the circuit.
