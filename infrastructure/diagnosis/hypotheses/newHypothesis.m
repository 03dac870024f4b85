% NEWHYPOTHESIS  Describes one explanation of the measurements.
%
% CALL: H = newHypothesis (KIND, MEMBERS, EXTENT)
%
%   KIND     'null': the calibrated model; 'single', 'pair': with the effects
%            MEMBERS, in the form of the library or in another one;
%            'discrepancy': the model plus an unknown misfit, see
%            discrepancyKinds
%   MEMBERS  1 x h, numbers of effects (default: none)
%   EXTENT   of the size of the unknown part. With effects it is the tangent of
%            the angle between what they do and what their laws make of it,
%            half-normal with the deviation EXTENT (default 0.42: a fifth is
%            below 0.1, a third above 0.4, a seventh above 0.6). Of a
%            discrepancy EXTENT is 1 x 2, median and logarithmic deviation of
%            its scale
%   H        struct kind, members, spread ('', 'form', 'discrepancy'), extent
%
% No law of a library is that of a real material: water on beads, bridges for
% cohesion, clumps for rolling friction move the targets as the listed effect
% does within tangents of 0.1 to 1 (docs/gap-figures.md).

function h = newHypothesis (kind, members, extent)
  if nargin < 2
    members = zeros (1, 0);
  end
  if nargin < 3
    % laws of LIGGGHTS in each other's place: docs/gap-figures.md
    extent = 0.42;
  end
  spread = '';
  if strcmp (kind, 'discrepancy')
    spread = kind;
  elseif ~isempty (members)
    spread = 'form';
  end
  h = struct ('kind', kind, 'members', members, 'spread', spread, ...
              'extent', extent);
end

%!assert (newHypothesis ('null').members, zeros (1, 0))
%!assert (newHypothesis ('null').spread, '')
%!assert (newHypothesis ('single', 3).spread, 'form')
%!assert (newHypothesis ('pair', [1, 3]).extent, 0.42)

% SPDX-License-Identifier: GPL-3.0-only
