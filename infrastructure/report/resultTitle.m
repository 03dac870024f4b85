% RESULTTITLE  What calibrated values are, in one line for whoever finds them alone.
%
% CALL: TEXT = resultTitle (C, DATE)
%
%   C     struct converged, reason: of newCalibration, or decoded calibration.json
%   DATE  text
%   TEXT  'CALIBRATED (2026-01-02): All targets are met ...', without a line end

function text = resultTitle (c, date)
  word = merge (isequal (c.converged, true), 'CALIBRATED', 'NOT CALIBRATED');
  text = sprintf ('%s (%s): %s', word, date, ...
                  oneLine (c.reason));
end

%!assert (resultTitle (struct ('converged', false, 'reason', "a\nb"), '2026-01-02'), ...
%!        'NOT CALIBRATED (2026-01-02): a b')
%!assert (resultTitle (struct ('converged', true, 'reason', 'a'), 'd'), ...
%!        'CALIBRATED (d): a')

% SPDX-License-Identifier: GPL-3.0-only
