% LEVELTEXT  At which level a verdict was reached, and whether it would hold.
%
% CALL: TEXT = levelText (GAP)
%
%   GAP   what gap.json says: its field level (finerLevel) is read
%   TEXT  end of a sentence; '' of a case without levels

function text = levelText (gap)
  text = '';
  level = jsonAt (gap, {'level'});
  if ~isstruct (level)
    return
  end
  names = cellstr (level.variables);
  rms = @(x) norm (x) / sqrt (numel (x));
  code = 'level.open';
  effects = cellstr (level.effects)(:)';
  effects = strjoin (effects(~cellfun (@isempty, effects)), ', ');
  values = struct ('at', namedValues (names, level.value, '%.3g'), ...
                   'finer', namedValues (names, level.finer, '%.3g'), ...
                   'shift', sprintf ('%.3g', rms (level.shift)), ...
                   'sd', sprintf ('%.2g', rms (level.shiftSd)), ...
                   'verdict', level.verdict, ...
                   'effects', repmat ([' (', effects, ')'], 1, ~isempty (effects)));
  if ~isempty (level.verdict)
    code = merge (level.holds, 'level.same', 'level.other');
  end
  text = sentence (code, values);
end

%!test
%! gap.level = struct ('variables', {{'scaleP'}}, 'value', 2, 'finer', 4 / 3, ...
%!                     'shift', [3, -4], 'shiftSd', [1, 1], 'verdict', 'named', ...
%!                     'effects', {{'tilt'}}, 'holds', true);
%! assert (levelText (gap), ...
%!         ['reached at scaleP = 2. At scaleP = 1.33, where the runs of ', ...
%!          'all levels predict a shift of the results by 3.54 +- 1 ', ...
%!          '(root mean square), it would be the same.']);
%! gap.level.holds = false;
%! assert (! isempty (strfind (levelText (gap), 'be: named (tilt).')));
%! gap.level.effects = {};
%! assert (! isempty (strfind (levelText (gap), 'be: named.')));
%! gap.level.verdict = '';
%! assert (! isempty (strfind (levelText (gap), 'it is open')));
%! assert (levelText (struct ('level', [])), '');

% SPDX-License-Identifier: GPL-3.0-only
