// rejected: circuit
// displace: a kernel.
