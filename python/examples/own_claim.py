"""A claim of one's own: judged, explained, and its certificate checked again by the kernel."""

import carom

CLAIMS = """
claim half "Half of the momentum"
given m, v > 0;  e in [0, 1]
prove (1 + e)/2*v <= v

claim whole "All of the energy"
given m, v > 0;  e in [0, 1]
prove ((1 + e)/2)^2 = 1
"""

audit = carom.audit(CLAIMS)
print(audit)
witness = audit["whole"].witness
assert witness is not None
print("the second fails at", witness.point)

certificate = audit["half"].certificate_text
assert certificate is not None
print(carom.check(CLAIMS, certificate))
print(carom.explain(CLAIMS, "half"))
