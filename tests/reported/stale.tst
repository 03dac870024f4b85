% Targets, limits or the model were changed after a calibration, and status and
% report went on saying "Calibrated, all targets met". And a case that was copied
% or checked out read "stopped", as the times of its files went by.

%!function [status, out] = after (folder, change)
%!  % status after a change of loadInput.m or another file, which is undone
%!  [name, from, to] = change{:};
%!  file = fullfile (folder, name);
%!  text = '';
%!  if isfile (file)
%!    text = fileread (file);
%!  end
%!  changed = strrep (text, from, to);
%!  if isempty (from)
%!    changed = [text, to];
%!  end
%!  assert (~isequal (changed, text), name);
%!  writeAtomic (file, changed);
%!  [status, out] = startCommand (folder, 'status');
%!  if isempty (text)
%!    unlink (file);
%!  else
%!    writeAtomic (file, text);
%!  end
%!endfunction
%!shared folder
%! folder = reportedCase ('stale');
%!test
%! [status, out] = startCommand (folder, 'run');
%! assert (status == 0, out);
%! [status, out] = startCommand (folder, 'status');
%! assert (status == 0 && ~isempty (strfind (out, 'result  Calibrated')), out);
%!test
%! changes = {'loadInput.m', '1.9, 1.5]', '1.9, 1.7]', '(targets changed)'; ...
%!            'loadInput.m', '1.0 2.0]', '1.0 3.0]', ...
%!            '(parameters or limits changed)'; ...
%!            'DEMmodels/M/runscript', '3+a', '3.1+a', '(model changed)'; ...
%!            'DEMmodels/M/OctaveFuns/getResults.m', '', "\n% \n", ...
%!            '(model changed)'};
%! for change = changes'
%!   [status, out] = after (folder, change(1:3));
%!   assert (status == 2, out);
%!   assert (~isempty (strfind (out, change{4})), out);
%!   assert (isempty (strfind (out, 'result  Calibrated')), out);
%!   assert (~isempty (strfind (out, 'decalioc run')), out);
%! end
%! % what only says where runs are made is none, nor is a remark in the form
%! [status, out] = after (folder, {'loadInput.m', 'Input.maxCPU = 1', ...
%!                                 "% a remark\n  Input.maxCPU = 2"});
%! assert (status == 0, out);

%!test
%! % the page and the export say it, too
%! file = fullfile (folder, 'loadInput.m');
%! text = fileread (file);
%! writeAtomic (file, strrep (text, '1.9, 1.5]', '1.9, 1.7]'));
%! [status, out] = startCommand (folder, 'report');
%! assert (status == 2 && ~isempty (strfind (out, '(targets changed)')), out);
%! page = fileread (fullfile (folder, 'results', 'report.html'));
%! at = strfind (page, '<span class="word">')(1);
%! assert (strncmp (page(at + 19:end), 'Result of an earlier input', 26));
%! [status, out] = startCommand (folder, 'export');
%! assert (status == 0 && ~isempty (strfind (out, '(targets changed)')), out);
%! writeAtomic (file, text);

%!test
%! % of a copy, whatever the times of its files; without its runs
%! copy = tempname ();
%! system (sprintf ('cp -r %s %s && touch -d 2030-01-01 %s/optim/M/*/job.json', ...
%!                  folder, copy, copy));
%! [status, out] = startCommand (copy, 'status');
%! assert (status == 0 && ~isempty (strfind (out, 'state   finished')), out);
%! rmdir (fullfile (copy, 'optim'), 's');
%! [~, out] = startCommand (copy, 'status');
%! assert (~isempty (strfind (out, 'state   finished')), out);
%! % a run begun after the result: it is not the end, whatever the times
%! system (sprintf (['cd %s/optim/M && n=$(ls | tail -1) && cp -r "$n" 0999 ', ...
%!                   '&& touch -d 2001-01-01 0999/*'], folder));
%! [~, out] = startCommand (folder, 'status');
%! assert (~isempty (strfind (out, 'state   stopped')), out);

% SPDX-License-Identifier: GPL-3.0-only
