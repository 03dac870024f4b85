% Issue 72, 3: an effect of one's own as a file effects/effectNAME.m with the four
% fields of extend.md alone, and files that lack one.

%!function [status, out] = checked (lines, words)
%!  raw = standInCase (tempname ());
%!  writeLoadInput (raw.folder);
%!  put = @(name, text) writeAtomic (fullfile (raw.folder, name), text);
%!  put ('loadEffects.m', "function e = loadEffects ()\n  e = {'sticky'};\nend\n");
%!  mkdir (fullfile (raw.folder, 'effects'));
%!  for model = {'First', 'Second'}
%!    file = fullfile (raw.folder, 'DEMmodels', model{1}, 'data.head');
%!    writeAtomic (file, [fileread(file), "variable cohPa equal 0\n"]);
%!  end
%!  put ('effects/effectSticky.m', ["function effect = effectSticky ()\n", lines, "\nend\n"]);
%!  [status, out] = startCommand (raw.folder, words);
%!endfunction
%!test
%! four = ["effect.name = 'sticky'; effect.variables = {'cohPa'};\n", ...
%!         "effect.neutral = 0; effect.limits = [0; 60];"];
%! for lines = {four, [four, "effect.unit = 'Pa'; effect.label = 'cohesion';"], ...
%!              strrep(four, "effect.name = 'sticky';", '')}
%!   [status, out] = checked (lines{1}, 'check --try');
%!   assert (status == 0, out);
%!   assert (! isempty (strfind (out, 'effects   sticky')), out);
%! end
%!test
%! for row = {"effect.variables = {'cohPa'}; effect.neutral = 0;", 'field limits'; ...
%!            "effect.variables = {'cohPa'}; effect.neutral = 0; effect.limits = [0, 60];", ...
%!            'limits 2 x 1'; 'effect = [];', 'must give a struct'; ...
%!            "effect.neutral = nought;", 'nought'}'
%!   [status, out] = checked (row{1}, 'check');
%!   assert (status == 1 && ! isempty (strfind (out, row{2})), out);
%!   assert (! isempty (strfind (out, 'effectSticky')), out);
%! end

% SPDX-License-Identifier: GPL-3.0-only
