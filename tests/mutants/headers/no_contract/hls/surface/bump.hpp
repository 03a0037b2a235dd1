// bump: the contract.
