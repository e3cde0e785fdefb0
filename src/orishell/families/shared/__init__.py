"""What several families share: sheets of the paper's sections 2 and 3, candidates, staircases."""
