"""The captions of the report's figures."""

CAPTIONS = {
    "divergence.png": """Forward Euler beside methods that hold. (a), (b): a small disturbance of the arm held at its
        set points, the share of the fastest motion in it, and the growth predicted from the spectrum. (c): the paper's
        task, the largest distance so far of the end point from a run of Runge–Kutta 4 at 20 µs.""",
    "fig03_joint_angles.png": """Paper's Fig. 3: joint angles against their references. At the start the arm falls,
        as a PD law gives no torque before there is an error; the offsets at the end are the weight over kp.""",
    "fig04_coordinates.png": """Paper's Fig. 4: coordinates of the link frames in body-fixed components, r_i =
        R_oiᵀ p_i, and exponential coordinates of R_oi. Link 1 sits on the inertial origin: r_1 = 0 throughout.""",
    "fig06_twists.png": """Paper's Fig. 6: twists of the link frames in body-fixed components; v_1 = 0 throughout.""",
    "fig07_end_point.png": """Paper's Fig. 7: end-point position in the inertial frame, and where straight links would
        hold it at the reference angles.""",
    "fig08_deformation.png": """Paper's Fig. 8: end-point deformation, that is how far the end point is from where
        straight links at the same joint angles would hold it, in inertial components. It includes the sag; the paper's
        measurement is high-passed.""",
    "fig08_spectrum.png": """Paper's spectrum figure: amplitude spectrum of the end-point deformation, its mean taken
        off, of the whole run and, under a Hann window, of the time after the motion. Vertical lines: oscillating
        motions of the linearised closed loop at the set points and at q = 0.""",
    "fig09_field_link1.png": """Paper's Fig. 9: displacement field along link 1, in F_1 components.""",
    "fig10_field_link2.png": """Paper's Fig. 10: displacement field along link 2, in F_2 components. The
        axial vibration is faster than the sampling: (a) shows its size, not its waves.""",
    "fig11_modal.png": """Paper's Fig. 11: modal coordinates of both links.""",
    "fig12_torques.png": """Paper's Fig. 12: joint torques, and those of the arm with rigid links under the
        same law.""",
    "fig13_base_wrench.png": """Paper's Fig. 13: wrench at the base joint, on link 1, in F_1 components; the paper's W_0
        is its reaction. Forces above, moments below.""",
    "fig14_joint_wrench.png": """Paper's Fig. 14: wrench at the connecting joint, on link 2, in F_2 components; the
        paper's W_1 is its reaction, moved into F_1. The band in (a) is axial vibration of a few µm that the release
        sets off. The arm hardly damps it (see the last but one row of the table of growth); that it decays faster here
        is the step of 1 ms.""",
}
"""Figures in the order of the report: file name and caption."""

CAPTIONS = {file: " ".join(caption.split()) for file, caption in CAPTIONS.items()}
