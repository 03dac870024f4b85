% LEVELTEXT  At which level a verdict was reached, and whether it would hold.
%
% CALL: TEXT = levelText (LEVEL)
%
%   LEVEL  of finerLevel, or what gap.json says of it
%   TEXT   one sentence

function text = levelText (level)
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
    codes = {'level.other', 'level.same'};
    code = codes{1 + level.holds};
  end
  text = sentence (code, values);
end

%!test
%! level = struct ('variables', {{'scaleP'}}, 'value', 2, 'finer', 4 / 3, ...
%!                 'shift', [3, -4], 'shiftSd', [1, 1], 'verdict', 'named', ...
%!                 'effects', {{'tilt'}}, 'holds', true);
%! assert (levelText (level), ...
%!         ['reached at scaleP = 2. At scaleP = 1.33, where the runs of ', ...
%!          'all levels predict a shift of the results by 3.54 +- 1 ', ...
%!          '(root mean square), it would be the same.']);
%! level.holds = false;
%! assert (! isempty (strfind (levelText (level), 'be: named (tilt).')));
%! level.effects = {};
%! assert (! isempty (strfind (levelText (level), 'be: named.')));
%! level.verdict = '';
%! assert (! isempty (strfind (levelText (level), 'it is open')));
