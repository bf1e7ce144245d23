"""What a VTK object reports as errors."""


def errors_of(algorithm):
    """What it reports from now on. The executive reports for a filter without input."""
    said = []

    def keep(_caller, _event, text):
        said.append(text)
    keep.CallDataType = "string0"
    algorithm.AddObserver("ErrorEvent", keep)
    return said
