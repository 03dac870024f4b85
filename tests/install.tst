% Flow of `make install` and `make uninstall`: below a folder with a blank.

%!shared root, prefix
%! root = fileparts (fileparts (which ('startProgram')));
%! prefix = fullfile (tempname (), 'a place');
%! mkdir (fileparts (prefix));

%!function [status, text] = install (root, prefix, target)
%!  [status, text] = system (sprintf ('make -C %s %s PREFIX=%s 2>&1', ...
%!                                    shellQuote (root), target, ...
%!                                    shellQuote (prefix)));
%!endfunction

%!function text = installed (prefix, varargin)
%!  text = fileread (fullfile (prefix, 'share', varargin{:}));
%!endfunction

%!test
%! % twice: the command works, all texts name all commands and the options
%! for k = 1:2
%!   [status, text] = install (root, prefix, 'install');
%!   assert (status == 0, text);
%! end
%! program = shellQuote (fullfile (prefix, 'bin', 'decalioc'));
%! [~, text] = system ([program, ' --version']);
%! assert (strncmp (text, 'decalioc ', 9), text);
%! [~, help] = system ([program, ' --help']);
%! names = regexp (help, '^  (\w+) ', 'tokens', 'lineanchors');
%! names = [names{:}];
%! bash = installed (prefix, 'bash-completion', 'completions', 'decalioc');
%! zsh = installed (prefix, 'zsh', 'site-functions', '_decalioc');
%! fish = installed (prefix, 'fish', 'vendor_completions.d', 'decalioc.fish');
%! page = installed (prefix, 'man', 'man1', 'decalioc.1');
%! for name = names
%!   has = @(text, word) ~isempty (strfind (text, [word{:}]));
%!   assert (has (regexprep (bash, '[\s'']', ' '), {' ', name{1}, ' '}), name{1});
%!   assert (has (zsh, {'''', name{1}, ':'}), name{1});
%!   assert (has (fish, {'-a ', name{1}, ' -d'}), name{1});
%!   assert (has (page, {'.SH decalioc ', name{1}}), name{1});
%! end
%! assert (has (zsh, {'check) options=(--try --dry-run)'}), zsh);
%! assert (has (fish, {'from check'' -l dry-run'}), fish);
%! assert (has (page, {'\-\-dry\-run'}), page);
%!test
%! % no line of help is a request of roff; no mistake that groff sees
%! page = installed (prefix, 'man', 'man1', 'decalioc.1');
%! requests = unique (regexp (page, '^[.''][^ \n]*', 'match', 'lineanchors'));
%! assert (requests, {'.SH', '.TH', '.fi', '.nf'});
%! [status, text] = system (['command -v groff > /dev/null || exit 0; ', ...
%!   'groff -man -ww -z ', ...
%!   shellQuote(fullfile (prefix, 'share', 'man', 'man1', 'decalioc.1')), ' 2>&1']);
%! assert (isempty (text), text);
%!test
%! % removed; a command that is no link of the toolbox stays
%! [status, text] = install (root, prefix, 'uninstall');
%! assert (status == 0, text);
%! [~, left] = system (['find ', shellQuote(prefix), ' ! -type d']);
%! assert (left, '');
%! mine = fullfile (prefix, 'bin', 'decalioc');
%! writeAtomic (mine, 'mine');
%! for target = {'install', 'uninstall'}
%!   [status, text] = install (root, prefix, target{1});
%!   assert (status ~= 0 && ~isempty (strfind (text, 'not made by this')), text);
%! end
%! assert (fileread (mine), 'mine');
%! [status, text] = install (root, 'relative', 'install');
%! assert (status ~= 0 && ~isempty (strfind (text, 'whole path')), text);

%!test
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (fileparts (prefix), 's');

% SPDX-License-Identifier: GPL-3.0-only
