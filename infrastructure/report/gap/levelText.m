% LEVELTEXT  At which level a verdict was reached, and whether it would hold.
%
% CALL: TEXT = levelText (LEVEL)
%
%   LEVEL  of finerLevel, or what gap.json says of it
%   TEXT   one sentence

function text = levelText (level)
  names = cellstr (level.variables);
  text = ['reached at ', namedValues(names, level.value, '%.3g'), '. At '];
  finer = namedValues (names, level.finer, '%.3g');
  rms = @(x) norm (x) / sqrt (numel (x));
  if isempty (level.verdict)
    text = [text, finer, ' it is open: the runs at the coarser levels ', ...
            'say nothing of it.'];
    return
  end
  text = sprintf (['%s%s, where the runs of all levels predict a shift of ' ...
                   'the responses by %.3g +- %.2g (root mean square), '], ...
                  text, finer, rms (level.shift), rms (level.shiftSd));
  if level.holds
    text = [text, 'it would be the same.'];
  else
    effects = cellstr (level.effects);
    names = '';
    if ~all (cellfun (@isempty, effects(:)))
      names = sprintf (' (%s)', strjoin (effects(:)', ', '));
    end
    text = [text, 'it would be: ', level.verdict, names, '.'];
  end
end

%!test
%! level = struct ('variables', {{'scaleP'}}, 'value', 2, 'finer', 4 / 3, ...
%!                 'shift', [3, -4], 'shiftSd', [1, 1], 'verdict', 'named', ...
%!                 'effects', {{'tilt'}}, 'holds', true);
%! assert (levelText (level), ...
%!         ['reached at scaleP = 2. At scaleP = 1.33, where the runs of ', ...
%!          'all levels predict a shift of the responses by 3.54 +- 1 ', ...
%!          '(root mean square), it would be the same.']);
%! level.holds = false;
%! assert (! isempty (strfind (levelText (level), 'be: named (tilt).')));
%! level.effects = {};
%! assert (! isempty (strfind (levelText (level), 'be: named.')));
%! level.verdict = '';
%! assert (! isempty (strfind (levelText (level), 'it is open')));
