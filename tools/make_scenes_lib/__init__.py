"""The scenes of vkpt, as code. Python standard library only."""
