% NEWHYPOTHESIS  Describes one explanation of the measurements.
%
% CALL: H = newHypothesis (KIND, MEMBERS, EXTENT)
%
%   KIND     'null': the calibrated model; 'single', 'pair': with the effects
%            MEMBERS; 'sibling': something that resembles MEMBERS, their
%            signature plus a part in a direction that nobody knows;
%            'discrepancy': the model plus an unknown misfit, see
%            discrepancyKinds
%   MEMBERS  1 x h, numbers of effects (default: none)
%   EXTENT   1 x 2, median and logarithmic deviation of the size of the unknown
%            part: of a sibling the tangent of the angle between its signature
%            and that of MEMBERS (default 0.6, 0.7: the middle 90 % have cosines
%            from 0.98 to 0.47), of a discrepancy its scale
%   H        struct kind, members, spread ('', 'sibling', 'discrepancy'), extent

function h = newHypothesis (kind, members, extent)
  if nargin < 2
    members = zeros (1, 0);
  end
  if nargin < 3
    extent = [0.6, 0.7];
  end
  spread = '';
  if any (strcmp (kind, {'sibling', 'discrepancy'}))
    spread = kind;
  end
  h = struct ('kind', kind, 'members', members, 'spread', spread, ...
              'extent', extent);
end

%!assert (newHypothesis ('null').members, zeros (1, 0))
%!assert (newHypothesis ('single', 3).spread, '')
%!assert (newHypothesis ('sibling', 3).extent, [0.6, 0.7])
