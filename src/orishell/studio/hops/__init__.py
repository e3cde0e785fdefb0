"""orishell in Grasshopper: components that Rhino's Hops asks for over HTTP."""
