"""The published results in the order of the page. A function's first line is its title, the rest what was published."""
import contact
import heights
import rough
import stress

ALL = [contact.westergaard, contact.egg_box, contact.punches, stress.hertz, stress.sliding, rough.area_law,
       rough.gap_and_stiffness, rough.rough_sphere, rough.percolation, heights.peaks, heights.summits, heights.kernels,
       rough.full_contact, stress.line_contact, rough.plastic, heights.spectrum, contact.off]
OFF = [contact.off]  # the published figure is wrong: neither error explains the difference


def words(name):
    """Title and text of a result."""
    (title, _, text) = next(result for result in ALL if result.__name__ == name).__doc__.partition("\n")
    return title.strip(), "\n".join(line.strip() for line in text.strip().splitlines())
